"""The generated blocks leave the cycle to the user: at most 5 % of 10 ms, on the bench's scale."""

from bench.statements import STATEMENTS_OF_FIVE_PERCENT, TOTAL, worst_scans


def test_all_blocks_together_stay_below_5_percent_of_a_cycle_of_10_ms() -> None:
    worst = worst_scans(sequences=True)
    assert worst["TOS_Telegram"] > 50
    assert worst["TOS_Drive"] > 100
    assert worst[TOTAL] < STATEMENTS_OF_FIVE_PERCENT
