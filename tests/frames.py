"""A frame of every kind of both protocols, for what is tried on all of them.

Printed frames are from `tests/vectors`; the others are written out.
"""

from pathlib import Path

import yaml

_VECTORS = Path(__file__).parent / "vectors" / "toshiba_frames.yaml"


def _vectors(mode: str) -> dict[str, bytes]:
    entries = yaml.safe_load(_VECTORS.read_text(encoding="utf-8"))["entries"]
    return {
        entry["id"]: bytes.fromhex(entry["bytes"])
        for entry in entries
        if entry["kind"] == "frame"
        and entry["mode"] == mode
        and entry.get("checksum_ok", True)
        and "xx" not in entry["bytes"]
    }


TOSHIBA_BINARY: dict[str, bytes] = {
    **_vectors("binary"),
    "read with R": bytes.fromhex("2F 0B 52 FC 90 18"),
    "read with R, no number": bytes.fromhex("2F 52 FC 90 0D"),
    "write with W, no number": bytes.fromhex("2F 57 00 10 00 64 FA"),
    "set-point S to all": bytes.fromhex("2F FF 53 FA 01 27 10 B3"),
    "set-point s to all": bytes.fromhex("2F FF 73 FA 01 27 10 D3"),
    "block X to number 11": bytes.fromhex("2F 0B 58 02 05 C4 00 17 70 E4"),
    "block X, nothing to write": bytes.fromhex("2F 0B 58 00 03 95"),
    "block Y of number 11": bytes.fromhex("2F 0B 59 05 00 64 00 17 70 1A 8A 24 FD 00 00 48"),
    "block y, tripped": bytes.fromhex("2F 0B 79 01 00 00 18 CC"),
}
ASCII_CHECKED: dict[str, bytes] = {
    "read": b"(R0000&60)\r",
    "write to number 11": b"(11PFA00C400&BE)\r",
    "write to all": b"(**PFA00C400&B0)\r",
    "reply of number 11": b"(11RFE03077B&D0)\r",
    "refusal of number 11": b"(11N0002&C0)\r",
}
MODBUS: dict[str, bytes] = {
    **_vectors("modbus_rtu"),
    "write": bytes.fromhex("01 06 FA 00 C4 00 EB D2"),
    "write and read": bytes.fromhex("01 17 18 75 00 05 18 70 00 02 04 C4 00 17 70 84 31"),
    "write and read, reply": bytes.fromhex("01 17 0A 64 00 17 70 1A 8A 24 FD 00 00 67 25"),
    "write to all": bytes.fromhex("00 06 FA 00 C4 00 EA 03"),
}
