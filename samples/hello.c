/* SPDX-License-Identifier: Apache-2.0
   A page of a picture from C:   hello photo.jpg photo.pdf "Hot air balloon" */
#include <stdio.h>
#include <tactics.h>

int main(int count, char **words) {
    if (count != 4) return TACTICS_USAGE;
    tactics_job *job = tactics_new();
    tactics_input(job, words[1]);
    tactics_output(job, words[2]);
    tactics_option(job, "title", words[3]);
    const tactics_code code = tactics_run(job);
    for (size_t i = 0; i < tactics_told_count(job); ++i) printf("%s\n", tactics_told(job, i));
    if (code != TACTICS_DONE) fprintf(stderr, "%s\n", tactics_message(job));
    tactics_free(job);
    return code;
}
