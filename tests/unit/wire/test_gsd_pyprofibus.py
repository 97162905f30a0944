"""pyprofibus, which was written by others, reads our GSD files as we do."""

from pathlib import Path

import pytest

from fbgen.wire.gsd import choose, read_gsd
from tests.unit.wire.foreign_gsd import foreign_station

ROOT = Path(__file__).parents[3]
FILES = [
    ROOT / "examples" / "manual_example" / "esco1803.gsd",
    Path(__file__).parent / "made_up_pbdp110.gsd",
]
SAME = {
    "GSD_Revision": "gsd_revision",
    "Vendor_Name": "vendor",
    "Model_Name": "model",
    "Revision": "revision",
    "Hardware_Release": "hardware_release",
    "Software_Release": "software_release",
    "Sync_Mode_supp": "sync",
    "Freeze_Mode_supp": "freeze",
    "Auto_Baud_supp": "auto_baud",
    "Set_Slave_Add_supp": "set_slave_address",
    "Fail_Safe": "fail_safe",
    "Modular_Station": "modular",
    "Modul_Offset": "module_offset",
    "Max_Diag_Data_Len": "max_diagnosis_bytes",
}


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_keywords_and_modules_are_the_same(path: Path) -> None:
    ours = read_gsd(path.read_bytes(), path.name)
    theirs = foreign_station(path.read_bytes())
    assert ours.ident_number == theirs.getIdentNumber()
    assert {key: getattr(ours, name) for key, name in SAME.items()} == {
        key: theirs.getField(key) for key in SAME
    }
    for rate in ours.rates:
        assert theirs.getField(f"{rate.name}_supp")
        assert rate.max_tsdr == theirs.getField(f"MaxTsdr_{rate.name}")
    assert [(one.name, one.code) for one in ours.modules] == [
        (one.name, bytes(one.configBytes)) for one in theirs.getField("Module")
    ]
    limits = ours.limits
    assert (limits.modules, limits.inputs, limits.outputs, limits.data) == tuple(
        theirs.getField(key)
        for key in ("Max_Module", "Max_Input_Len", "Max_Output_Len", "Max_Data_Len")
    )


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_each_module_alone_gives_the_same_configuration(path: Path) -> None:
    ours = read_gsd(path.read_bytes(), path.name)
    for module in ours.modules:
        theirs = foreign_station(path.read_bytes())
        theirs.clearConfiguredModules()
        theirs.setConfiguredModule(module.name)
        elements = theirs.getCfgDataElements()
        assert choose(ours, (module.name,)).code == b"".join(bytes(one.getDU()) for one in elements)
