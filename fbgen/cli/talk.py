"""`fbgen talk`: single telegrams to inverters at a serial port, and the search for them."""

import shlex
import sys
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli import FINDINGS
from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption, JsonOption
from fbgen.cli.output import on_error_terminal, report, result, result_json, say
from fbgen.cli.ports.line_options import (
    BaudOption,
    ParityOption,
    PortOption,
    ProtocolOption,
    asked_setting,
)
from fbgen.cli.progress import Progress

if TYPE_CHECKING:
    from fbgen.cli.frames.cell_texts import CellTexts
    from fbgen.cli.ports.talk_answers import Answer
    from fbgen.cli.ports.talk_requests import Question, Talking
    from harness.serial import Asking, LineSetting, Port

_HELP = (
    "read [INV-NO] COMNO ...            read 11 output_current, read 1-5 FD01 FC90\n"
    "write [INV-NO] COMNO VALUE ...     write 11 frequency 50, write 11 FA01 1388h\n"
    "                                   write 11 command run forward network_command\n"
    "   --eeprom writes for good (W), --yes starts a motor without being asked again\n"
    "names                              the ComNos of the series\n"
    "help, quit"
)


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen talk --port COM3 read 11 output_current",
            "fbgen talk --port /dev/ttyUSB0 --baud 19200 write 11 frequency 50",
            "fbgen talk --port COM3 write 11 command run forward network_command network_frequency",
            "fbgen talk --port COM3 write 11 F803 2 --eeprom",
            "fbgen talk --port COM3 --protocol modbus read 1-5 status trip --json",
            "fbgen talk --port COM3 scan                 over all numbers, speeds and parities",
            "fbgen talk --port COM3                      asks for commands; help lists them",
        )
    )(talk)


def talk(
    port: PortOption,
    words: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="WORDS",
            help="read [INV-NO] COMNO, write [INV-NO] COMNO VALUE, scan; nothing asks for them.",
        ),
    ] = None,
    inv_no: Annotated[
        int | None,
        typer.Option("--inv-no", metavar="N", min=0, max=247, help="Where the words name none."),
    ] = None,
    series: Annotated[
        str, typer.Option("--series", metavar="S", help="Series, for names, units and defaults.")
    ] = "vf-s11",
    protocol: ProtocolOption = None,
    baud: BaudOption = None,
    parity: ParityOption = None,
    ascii_frames: Annotated[
        bool, typer.Option("--ascii", help="Toshiba frames in ASCII instead of binary.")
    ] = False,
    timeout: Annotated[
        str, typer.Option("--timeout", metavar="T", help="How long to wait for a reply.")
    ] = "300 ms",
    eeprom: Annotated[
        bool, typer.Option("--eeprom", help="Write for good; a cell stands some 10,000 writes.")
    ] = False,
    yes: Annotated[bool, typer.Option("--yes", help="Start a motor without asking.")] = False,
    numbers: Annotated[
        str | None,
        typer.Option("--numbers", metavar="N", help="Of scan: 1-5,11; else all up to 63."),
    ] = None,
    verbose: Annotated[
        bool, typer.Option("-v", "--verbose", help="Show the bytes sent and received.")
    ] = False,
    catalog: CatalogOption = None,
    as_json: JsonOption = False,
) -> None:
    """Ask real or simulated inverters one by one: names, units and errors instead of bytes.

    Starting a motor takes --yes or an answer to a question: somebody may stand beside it.
    """
    from fbgen.catalog import load_catalog
    from fbgen.cli.frames.cell_texts import CellTexts
    from fbgen.cli.ports.talk_requests import Form, Talking
    from harness.serial import Asking, protocol_of, serial_port

    known = load_catalog(catalog or ()).drive(series)
    setting = asked_setting([known], protocol, baud, parity)
    form = Form.ASCII if ascii_frames else Form.BINARY
    talking = Talking(known, setting.protocol, form, inv_no)
    cells = CellTexts(known)
    if words and words[0] == "scan":
        _scan(port, words, setting, talking, baud, parity is not None, numbers, as_json)
        return
    timeout_ns = _time_ns(timeout)
    opened = serial_port(port, setting.from_master)
    try:
        asking = Asking(opened, protocol_of(setting), setting.from_master, timeout_ns)
        if verbose:
            asking.told = _tell_bytes
        session = _Session(asking, talking, cells, as_json=as_json)
        if words:
            marked = [*words, *(["--eeprom"] if eeprom else []), *(["--yes"] if yes else [])]
            session.carry_out(marked)
        elif not session.converse(yes=yes):
            raise typer.Exit(FINDINGS)
    finally:
        opened.close()


class _Session:
    """Carries lines out, one after the other."""

    def __init__(
        self, asking: "Asking", talking: "Talking", cells: "CellTexts", *, as_json: bool
    ) -> None:
        self._asking = asking
        self._talking = talking
        self._cells = cells
        self._as_json = as_json

    def carry_out(self, words: Sequence[str]) -> None:
        """Ask everything that a line asks for.

        Raises DiagnosticError FB9050 to FB9053 and those of names and values; of several
        inverters all are asked first.
        """
        from fbgen.cli.ports.talk_answers import answer_json, answer_text
        from fbgen.cli.ports.talk_requests import questions
        from fbgen.diagnostics import Diagnostic, DiagnosticError

        asked = questions([word for word in words if word != "--yes"], self._talking)
        for question in asked:
            if question.starts and "--yes" not in words:
                _confirm(question)
        found: list[Diagnostic] = []
        answers: list[Answer] = []
        for question in asked:
            if question.warning:
                say(f"note: {question.warning}")
            try:
                answer = self._ask(question)
            except DiagnosticError as wrong:
                found += wrong.diagnostics
                continue
            answers.append(answer)
            if not self._as_json:
                result(answer_text(answer, self._cells))
        if self._as_json:
            result_json({"answers": [answer_json(one, self._cells) for one in answers]})
        if found:
            raise DiagnosticError(found)

    def _ask(self, question: "Question") -> "Answer":
        from fbgen.cli.ports.talk_answers import answer_of

        heard = self._asking.ask(question.frame, answered=question.answered)
        return answer_of(question, heard, self._talking)

    def converse(self, *, yes: bool) -> bool:
        """Carry out the lines of a person or a file up to `quit`; False if one was wrong."""
        from fbgen.diagnostics import DiagnosticError

        good = True
        for words in _lines(self._names()):
            if words == ["help"]:
                say(_HELP)
            elif words == ["names"]:
                result("\n".join(_name_rows(self._talking)))
            else:
                try:
                    self.carry_out([*words, "--yes"] if yes else words)
                except DiagnosticError as wrong:
                    report(wrong.diagnostics)
                    good = False
        return good

    def _names(self) -> list[str]:
        series = self._talking.series
        bits = [field.name for word in series.words for field in word.bits]
        return ["read", "write", "names", *(comno.name for comno in series.comnos), *bits]


def _lines(names: Sequence[str]) -> Iterator[list[str]]:
    """The lines that are typed or come from a file, as words; with history where there is one."""
    prompt = "fbgen> " if sys.stdin.isatty() else ""
    if prompt:
        _complete(names)
    while True:
        try:
            line = input(prompt)
        except EOFError:
            return
        try:
            words = shlex.split(line, comments=True)
        except ValueError:
            words = line.split()
        if words[:1] in (["quit"], ["exit"]):
            return
        if words:
            yield words


def _complete(names: Sequence[str]) -> None:
    """History and completion by readline, where Python has it."""
    from importlib import import_module
    from importlib.util import find_spec

    if find_spec("readline") is None:
        return
    readline = import_module("readline")

    def completed(text: str, state: int) -> str | None:
        found = [name for name in dict.fromkeys(names) if name.startswith(text)]
        return f"{found[state]} " if state < len(found) else None

    readline.set_completer(completed)
    readline.set_completer_delims(" ")
    readline.parse_and_bind("tab: complete")


def _name_rows(talking: "Talking") -> Iterator[str]:
    for comno in talking.series.comnos:
        unit = f" [{comno.unit}]" if comno.unit else ""
        yield f"{comno.hex}  {comno.name}{unit}: {comno.title}"


def _confirm(question: "Question") -> None:
    """Ask whether a motor may be started. Raises DiagnosticError FB9053 if not."""
    from fbgen.diagnostics import error

    who = "all inverters" if question.inv_no is None else f"inverter {question.inv_no}"
    if sys.stdin.isatty() and typer.confirm(f"This starts the motor of {who}. Go on?", err=True):
        return
    raise error(
        "FB9053",
        f"this would start the motor of {who}; nothing was sent",
        None,
        "see that nobody is at the machine, then add --yes",
    )


def _tell_bytes(direction: str, data: bytes, took_ns: int) -> None:
    from fbgen.cli.frames.frame_lines import frame_bytes

    arrow = ">" if direction == "sent" else "<"
    say(f"{took_ns / 1e6:9.3f} ms {arrow} {frame_bytes(data)}")


def _time_ns(text: str) -> int:
    from fbgen.diagnostics import error
    from harness.durations import read_duration

    try:
        return read_duration(text)
    except ValueError as wrong:
        raise error("FB9050", f"--timeout: {wrong}", None, "write --timeout 500ms") from None


def _scan(
    name: str,
    words: Sequence[str],
    setting: "LineSetting",
    talking: "Talking",
    baud: int | None,
    parity_is_said: bool,
    numbers: str | None,
    as_json: bool,
) -> None:
    from fbgen.cli.ports.talk_scan import scan, scan_numbers, scan_settings
    from fbgen.diagnostics import error
    from harness.serial import has_speed, serial_port

    if len(words) > 1:
        raise error("FB9050", "scan takes no words", None, "write: scan --numbers 1-5,11")
    wanted = scan_numbers(numbers, setting.protocol)
    settings = [setting]
    if has_speed(name):
        parity = setting.parity if parity_is_said else None
        settings = scan_settings(setting, talking, baud, parity)
    total = len(settings) * len(wanted)
    progress = Progress(total, shown=on_error_terminal())

    def opened(one: "LineSetting") -> "Port":
        return serial_port(name, one.from_master)

    found = []
    for item in scan(settings, wanted, talking, opened, progress.step):
        found.append(item)
        if not as_json:
            progress.end()
            place = f"{item.baud} bit/s, parity {item.parity}" if has_speed(name) else name
            result(f"INV-NO {item.inv_no}: {place}")
    progress.end()
    if as_json:
        rows = [{**item._asdict(), "reply": item.reply.hex(" ").upper()} for item in found]
        result_json({"found": rows})
    if not found:
        raise error(
            "FB9051",
            f"no inverter has answered to {len(wanted)} numbers with {len(settings)} settings",
            None,
            "check power, wiring and whether the two wires of a pair are exchanged; the protocol "
            f"was {setting.protocol}",
        )
    say(f"{len(found)} found, {total} questions")
