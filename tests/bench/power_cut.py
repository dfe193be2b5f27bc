# SPDX-License-Identifier: Apache-2.0
"""The judge of tests/bench/power_cut: it starts the machine, cuts its power, mends the disk and looks at what is on it.

A log of a disk is that of Linux' dm-log-writes, as qemu's blklogwrites writes it: a sector of the log's own (magic, version, entries,
size of a sector), then for each entry a sector (first sector, sectors, flags, bytes) and its data."""
import argparse, os, random, re, shutil, struct, subprocess, sys, time, zlib
from pathlib import Path

SECTOR = 512
FLUSH, DISCARD = 1, 4
FILE_SYSTEM = 48 << 20  # bytes; behind it are the sectors of what was told
DISK = FILE_SYSTEM + (4 << 20)
SERIAL_HOLDS = 4096 + 64  # bytes that Linux keeps for a line and a 16550 keeps itself
PICTURES, JOB_PAGES = 40, 40


def png(width, height, grey_at):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + bytes(grey_at(x, y) for x in range(width)) for y in range(height))
    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def make_pictures(guest):
    chance = random.Random(1)
    (guest / "pictures").mkdir(parents=True)
    for number in range(PICTURES):
        x0, y0, r = chance.randint(25, 70), chance.randint(20, 50), chance.randint(8, 20)
        disc = png(96, 72, lambda x, y: 60 if (x - x0) ** 2 + (y - y0) ** 2 < r * r else 220)
        (guest / "pictures" / f"p{number:02}.png").write_bytes(disc)
    page = "\r\n".join(["power cut in the middle of a line"] * 25)
    (guest / "job.brf").write_text("\f".join([page] * JOB_PAGES) + "\f", newline="")


class Machine:
    def __init__(self, options, disk, log=None):
        self.scratch = options.scratch
        self.serial = self.scratch / "embosser"
        self.serial.unlink(missing_ok=True)
        drive = f"driver=raw,node-name=plain,file.driver=file,file.filename={disk}"
        blocks = ["-blockdev", drive]
        if log:
            log.write_bytes(b"")
            blocks += ["-blockdev", f"driver=blklogwrites,node-name=logged,file=plain,log-super-update-interval=1,"
                       f"log.driver=file,log.filename={log}"]
        self.process = subprocess.Popen(
            options.machine + ["-m", "512", "-smp", "2", "-initrd", str(self.scratch / "initrd"), "-append",
                               f"{options.words} FILE_SYSTEM={FILE_SYSTEM}", *blocks, "-device",
                               f"virtio-blk-pci,drive={'logged' if log else 'plain'},write-cache=on", "-serial", "stdio", "-serial",
                               f"file:{self.serial}"],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE)
        os.set_blocking(self.process.stdout.fileno(), False)
        self.said = b""

    def listen(self, until, seconds):
        """Until `until` is said, or the time is over."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            more = self.process.stdout.read()
            if more:
                self.said += more
            if until is not None and until in self.said:
                return True
            if more == b"" and self.process.poll() is not None:
                return False
            time.sleep(0.01)
        return False

    def kill(self):
        self.process.kill()
        self.process.wait()
        self.said += self.process.stdout.read() or b""

    def told(self):
        whole = self.said[: self.said.rfind(b"\n") + 1].decode(errors="replace").replace("\r", "")
        return [line[5:] for line in whole.split("\n") if line.startswith("TOLD ")]


def fresh_disk(path):
    path.unlink(missing_ok=True)
    with open(path, "wb") as disk:
        disk.truncate(DISK)
    subprocess.run(["mkfs.ext4", "-q", "-F", "-b", "4096", str(path), str(FILE_SYSTEM // 4096)], check=True)


def pages_told(lines):
    return {name for line in lines for name in re.findall(r"/disk/pages/([\w.-]+?\.(?:pdf|png|brf))\b", line)}


class Judge:
    def __init__(self, options):
        self.options, self.wanted, self.bad = options, {}, 0

    def tell(self, what):
        self.bad += 1
        print("BAD: " + what, flush=True)

    def look(self, disk, told, what):
        """Mends the disk, compares, and lets --update go on. How many pages were there."""
        mended = subprocess.run(["e2fsck", "-fy", str(disk)], capture_output=True, text=True)
        if mended.returncode > 1:
            self.tell(f"{what}: ext4 did not mend itself: {mended.stdout[-300:]}")
        kept = self.options.scratch / "kept"
        shutil.rmtree(kept, ignore_errors=True)
        kept.mkdir()
        subprocess.run(["debugfs", "-R", f"rdump /pages {kept}", str(disk)], capture_output=True)
        pages = kept / "pages"
        there = {one.name: one.read_bytes() for one in pages.iterdir() if not one.name.startswith(".")} if pages.is_dir() else {}
        for name in sorted(pages_told(told)):
            if name not in there:
                self.tell(f"{what}: {name} was told as made and is not there")
        for name, data in there.items():
            if name in self.wanted and data != self.wanted[name]:
                self.tell(f"{what}: {name} is there with {len(data)} bytes of {len(self.wanted[name])}, or others")
        if self.convert(pages, update=True) != self.wanted:
            self.tell(f"{what}: --update does not make what is missing")
        return len(there)

    def convert(self, pages, update=False):
        command = [self.options.tactics, "convert", "-o", f"{pages}/", "--to", "pdf", "--to", "heightmap", "--to", "brf", "--quiet",
                   "--no-sync"] + (["--update"] if update else [])
        command += sorted(str(one) for one in (self.options.scratch / "guest" / "pictures").iterdir())
        subprocess.run(command, check=True)
        # A name of a file that was being written stays for a day: it may be another machine's (tactics/transport/unfinished.h).
        return {one.name: one.read_bytes() for one in pages.iterdir() if one.is_file() and not one.name.startswith(".tactics-")}

    def hear(self, told, serial, sent, what):
        """What was told of the job, against what came out of the line."""
        if not sent.startswith(serial):
            self.tell(f"{what}: the line gave other bytes than a job has")
        pages = [int(page) for line in told for page in re.findall(r"page (\d+) of \d+ accepted", line)]
        return max(pages, default=0)


def entries(log):
    """(first sector, flags, data) of each entry, in order."""
    with open(log, "rb") as file:
        magic, version, count, size = struct.unpack("<QQQI", file.read(28))
        assert magic == 0x6A736677736872 and version == 1, "not a log of writes"
        file.seek(size)
        for _ in range(count):
            first, sectors, flags, _ = struct.unpack("<QQQQ", file.read(32))
            file.seek(size - 32, 1)
            data = b"" if flags & DISCARD else file.read(sectors * size)
            yield first * size, flags, data


def cut_everywhere(options, judge):
    """One run with a log, then a disk for each of the cuts. Rows of what was found."""
    disk, log = options.scratch / "disk", options.scratch / "log"
    fresh_disk(disk)
    empty = disk.read_bytes()
    machine = Machine(options, disk, log)
    if not machine.listen(b"END", 900):
        machine.kill()
        sys.exit("the machine did not come to its end:\n" + machine.said.decode(errors="replace")[-2000:])
    time.sleep(1)
    machine.kill()
    told = machine.told()
    judge.sent = machine.serial.read_bytes()
    history = list(entries(log))
    writes = [n for n, (first, _, data) in enumerate(history) if data and first < FILE_SYSTEM]
    begin = next(n for n, (first, _, data) in enumerate(history) if first >= FILE_SYSTEM and data)
    chance = random.Random(7)
    places = sorted(chance.sample(range(begin, len(history)), min(options.cuts, len(history) - begin)))
    safe, loose, lines, done, most = bytearray(empty), [], [], 0, 0
    for place in places:
        for first, flags, data in history[done:place]:
            if first >= FILE_SYSTEM and data:
                lines.append(data.rstrip(b"\0").decode(errors="replace")[5:])
            elif data:
                loose.append((first, data))
            if flags & FLUSH:
                for start, old in loose:
                    safe[start : start + len(old)] = old
                loose = []
        done = place
        most = max(most, len(loose))
        image = bytearray(safe)
        kept = [one for one in loose if chance.random() < 0.5]
        for start, data in kept:
            image[start : start + len(data)] = data
        cut = options.scratch / "cut"
        cut.write_bytes(image)
        judge.look(cut, lines, f"cut at {place} of {len(history)} writes")
    return len(places), len(told), len(writes), most


def kill_again_and_again(options, judge):
    disk = options.scratch / "disk"
    chance = random.Random(11)
    longest, pages, most_behind = None, [], 0
    for number in range(options.kills):
        fresh_disk(disk)
        machine = Machine(options, disk)
        if not machine.listen(b"BEGIN", 600):
            machine.kill()
            sys.exit("the machine did not begin:\n" + machine.said.decode(errors="replace")[-2000:])
        if longest is None:  # the first tells how long it takes
            began = time.monotonic()
            machine.listen(b"END", 600)
            longest = time.monotonic() - began
        else:
            machine.listen(b"END", chance.uniform(0, longest))
        machine.kill()
        told = machine.told()
        what = f"kill {number + 1}"
        pages.append(judge.look(disk, told, what))
        serial = machine.serial.read_bytes() if machine.serial.exists() else b""
        complete = judge.hear(told, serial, judge.sent, what)
        ends = [n + 1 for n, byte in enumerate(judge.sent) if byte == 0x0C]
        behind = (ends[complete - 1] if 0 < complete <= len(ends) else 0) - len(serial)
        most_behind = max(most_behind, behind)
        if behind > SERIAL_HOLDS:
            judge.tell(f"{what}: page {complete} was told as accepted, and {behind} bytes of it are not at the machine")
    return pages, most_behind


def run(options):
    judge = Judge(options)
    judge.wanted = judge.convert(options.scratch / "whole")
    cuts, told, writes, most = cut_everywhere(options, judge)
    print(f"| cut of one run's {writes} writes ({told} lines told; {most} writes not flushed at most) | {cuts} |", flush=True)
    if options.kills:
        pages, behind = kill_again_and_again(options, judge)
        print(f"| killed; {min(pages)} to {max(pages)} of {len(judge.wanted)} files there; {behind} bytes of a page told as accepted "
              f"still in the line at most | {len(pages)} |")
    print(f"| lost or broken | {judge.bad} |")
    return 1 if judge.bad else 0


if __name__ == "__main__":
    if sys.argv[1] == "pictures":
        make_pictures(Path(sys.argv[2]))
    else:
        own, machine = sys.argv[2:], []
        if "--" in own:
            at = own.index("--")
            own, machine = own[:at], own[at + 1 :]
        parser = argparse.ArgumentParser()
        parser.add_argument("scratch", type=Path)
        parser.add_argument("--cuts", type=int)
        parser.add_argument("--kills", type=int)
        parser.add_argument("--words")
        parser.add_argument("--tactics")
        options = parser.parse_args(own)
        options.machine = machine
        sys.exit(run(options))
