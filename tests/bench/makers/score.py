# SPDX-License-Identifier: Apache-2.0
"""What became of a figure's words on the page that the program made of it."""
import html
import json
import re
import subprocess

import line_score
from figure import SCANS

COLUMNS = ("figures", "words", "right", "wrong", "told", "silent", "titles", "titles right", "titles wrong", "blank", "hard", "soft", "unsaid",
           "failed")
RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻₀₁₂₃₄₅₆₇₈₉", "0123456789-0123456789")
NEAR = 6  # percent: a line of braille off its place, or the middle of words that were guessed to be longer


def plain(text):
    """Words as they are compared: raised figures and one sign for minus."""
    text = re.sub("[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+", lambda m: "^" + m[0].translate(RAISED), text)
    return " ".join(text.translate(RAISED).replace("−", "-").replace("µ", "μ").replace("\u2126", "Ω").replace("ϕ", "φ").split())


def near(one, label):
    text, x, y = label
    if x is None:
        return True
    wide = NEAR + len(text)
    return abs(one["x_percent"] - x) <= wide and abs(one["y_percent"] - y) <= wide


def score(program, source, figure, form, page):
    row = dict.fromkeys(COLUMNS, 0) | {"figures": 1, "seconds": 0.0, "faults": [], "lines": None}
    run = subprocess.run([program, "convert", source, "-o", page, "--json"], capture_output=True, text=True, check=False)
    parts = lambda text: plain(text).split()
    words = figure.words_as(form)
    row["words"] = sum(len(parts(text)) for text, _, _ in words)
    if run.returncode != 0:
        row["failed"] = 1
        row["told"] = row["words"]
        row["faults"].append(run.stderr.strip()[-200:])
        return row
    answer = json.loads(run.stdout)
    with open(page + ".json", "w", encoding="utf-8") as file:
        file.write(run.stdout)
    row["seconds"] = answer["seconds"]
    row["blank"] = int(answer["outputs"][0]["empty"])
    if form not in SCANS:  # which are not quite level, so that its places are not those of the truth
        row["lines"] = line_score.score(page, answer, figure)
    rules = subprocess.run([program, "check", page, "--json"], capture_output=True, text=True, check=False)
    broken = {rule["rule"]: rule["hard"] for rule in json.loads(rules.stdout)["rules"] if rule["findings"]}
    row["hard"] = int(any(broken.values()))
    row["soft"] = int(not all(broken.values()))
    unsaid = broken.keys() - {rule["rule"] for rule in answer["outputs"][0].get("broken_rules", [])}
    row["unsaid"] = len(unsaid)
    row["faults"] += [f"unsaid {rule}" for rule in sorted(unsaid)]
    with open(page, encoding="utf-8") as file:
        title = re.search('data-tactics-title="([^"]*)"', file.read())
    title = plain(html.unescape(title[1])) if title else ""
    row["titles"] = int(figure.title != "")
    row["titles right"] = int(title != "" and title == plain(figure.title))
    row["titles wrong"] = int(title != "" and title != plain(figure.title))
    if title != plain(figure.title):
        row["faults"].append(f'title "{title}"')
    found = answer.get("words", [])
    stands = [w for w in found if w["set"]]
    told = [w for w in found if not w["set"]]
    left = []  # words of labels that are not set, with their label
    pool = [[part, w] for w in stands for part in parts(w["text"])]
    for label in words:
        for part in parts(label[0]):
            match = next((one for one in pool if one[0] == part and near(one[1], label)), None)
            if match:
                pool.remove(match)
                row["right"] += 1
            else:
                left.append((part, label))
    row["wrong"] = len(pool)
    row["faults"] += [f"wrong {part}" for part, _ in pool]
    hints = [[part, w] for w in told for part in (parts(w["text"]) or [""])]
    for part, label in left:
        match = next((one for one in hints if one[0] == part and near(one[1], label)), None) or \
            next((one for one in hints if label[1] is not None and near(one[1], label)), None) or \
            next((one for one in hints if one[0] == "" and label[1] is None), None)
        if match or part in parts(run.stderr):
            row["told"] += 1
            row["faults"].append(f"told {part}")
            if match and match[0] == part:
                hints.remove(match)
        else:
            row["silent"] += 1
            row["faults"].append(f"silent {part}")
    return row


def table(rows):
    """Rows of (maker, form, row) as a table of Markdown."""
    sums = {}
    for maker, form, row in rows:
        for key in ((maker, form), ("all", form)):
            total = sums.setdefault(key, dict.fromkeys(COLUMNS, 0) | {"seconds": 0.0})
            for name in total:
                total[name] += row[name]
    lines = ["| figures of | as | " + " | ".join(COLUMNS) + " | seconds a figure |", "|---|---" + "|---" * (len(COLUMNS) + 1) + "|"]
    for (maker, form), total in sorted(sums.items(), key=lambda item: (item[0][1], item[0][0] == "all", item[0][0])):
        lines.append(f"| {maker} | {form} | " + " | ".join(str(total[name]) for name in COLUMNS)
                     + f" | {total['seconds'] / total['figures']:.2f} |")
    return "\n".join(lines) + "\n"
