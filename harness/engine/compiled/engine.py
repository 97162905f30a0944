"""A checked program, compiled to Python and loaded on a controller."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from types import CodeType, MappingProxyType
from typing import Any, NoReturn

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import IN_OUTS, AnyBlock, Block, Program, Variable, VariableKind
from fbgen.lang.checked.variables import IN_GLOBALS, RECEIVER
from fbgen.lang.types import BlockType, OpenArrayType, ReferenceType, Type
from harness.engine.compiled.code import Listing
from harness.engine.compiled.data.areas import read_located, write_located
from harness.engine.compiled.data.cells import ValueCell
from harness.engine.compiled.data.held import held_in
from harness.engine.compiled.data.initials import Initializer
from harness.engine.compiled.data.located import found_at, located_at
from harness.engine.compiled.data.memory import Location, Memory
from harness.engine.compiled.data.model import GLOBALS, Record, is_scalar, run_method
from harness.engine.compiled.data.placement import Bytes
from harness.engine.compiled.data.programs import programs
from harness.engine.compiled.expressions.open_arrays import OpenArray
from harness.engine.compiled.generation import clock_of
from harness.engine.compiled.library.counters import counter_classes
from harness.engine.compiled.library.timers import timer_classes
from harness.engine.compiled.namespace import LIBRARY, Cpu, counting, hardware
from harness.engine.compiled.outside.arguments import by_variable, given_inputs
from harness.engine.compiled.outside.calls import write_keyword_call
from harness.engine.compiled.outside.instance import CompiledInstance
from harness.engine.compiled.outside.readers import written_reader
from harness.engine.compiled.outside.signatures import signature
from harness.engine.compiled.outside.variants import new_variable, reference_to
from harness.engine.compiled.statements.going_on import going_on
from harness.engine.compiled.statements.routines import Routines, unmodelled_classes
from harness.engine.compiled.stopping import Stopper
from harness.engine.compiled.translation import Translation, Unit, translation_of
from harness.engine.compiled.watching.probes import Probe
from harness.engine.environment import Environment
from harness.engine.faults import missing_argument, unknown_name, wrong_kind_of_block
from harness.engine.interface import (
    Convert,
    FunctionResult,
    Limits,
    Reader,
    Reference,
    State,
    Value,
)
from harness.engine.starting import own_starts
from harness.engine.values import accept, accept_scalar, array_of

_GIVEN = (VariableKind.INPUT, *IN_OUTS)
"""What a call from outside gives an instance."""


class CompiledEngine:
    """One program on one controller. `probe` looks on while it runs; `writers`: who wrote what;
    `programs`: its PROGRAMs by the names of their instances, with what each keeps."""

    __slots__ = (
        *("_bytes", "_cpu", "_environment", "_facts", "_globals", "_initial", "_listings", "_own"),
        *("_located", "_makers", "_memory", "_model", "_namespace", "_program", "programs"),
        *("_fresh_code", "_records", "_routines", "_runs", "_stopper", "writers"),
    )

    def __init__(
        self,
        program: Program,
        environment: Environment,
        limits: Limits | None = None,
        probe: Probe | None = None,
    ) -> None:
        limits = limits or Limits()
        self._program = program
        self._environment = environment
        self.writers = probe.writers if probe is not None else None
        library: dict[str, type] = {
            **timer_classes(
                clock_of(environment), today=program.dialect == "tia" and not environment.classic
            ),
            **counter_classes(program.dialect),
            **unmodelled_classes(program),
        }
        if self.writers is not None:
            library = self.writers.with_room(library, program.standard_blocks.values())
        translation = translation_of(program, library, environment, limits, probe)
        self._model = translation.model
        self._facts = translation.facts
        self._cpu = Cpu(limits)
        self._namespace: dict[str, Any] = {
            **LIBRARY,
            **library,
            **counting(self._cpu, limits),
            **going_on(self._cpu, self._stopped),
            "_environment": environment,
            "_cpu": self._cpu,
            "_set_others": self._set_others,
            "_stopped_by": self._stopped,
            **(probe.names if probe is not None else {}),
        }
        self._bytes = Bytes(translation.shapes, self._namespace, environment)
        self._memory = Memory(self._model, self._facts, self._namespace)
        self._namespace |= hardware(self._memory, self._bytes, environment)
        self._routines = Routines(program, environment, self._memory, self._cpu.retrigger)
        self._namespace["_routine"] = self._routines.call
        self._listings: dict[str, Listing] = {}
        self._stopper = Stopper(self._listings, limits)
        self._located = {
            variable.name.casefold(): variable
            for variable in program.globals.values()
            if variable.address is not None
        }
        self._globals = self._load(translation)
        self.programs = dict(programs(self._model, self._namespace))
        self._own = [key for key in self.programs if program.program_variable(key) is None]
        self._runs: dict[str, Callable[[], Any]] = {}
        self._makers: dict[str, Callable[..., Any]] = {}
        self._fresh_code: dict[Variable, CodeType] = {}
        self._records = {
            self._namespace[record.class_name]: record for record in self._model.block_records
        }
        self._initial = self.snapshot()
        self._start_instances(retains=True)

    # --- loading ------------------------------------------------------------------------------

    def _load(self, translation: Translation) -> object:
        """Make the classes and functions of the program, and the object with its variables."""
        for unit in translation.blocks:
            self._run_unit(unit)
        self._run_unit(translation.structures)
        self._namespace |= self._bytes.unions()
        self._namespace |= self._bytes.blocks()
        record = self._model.global_record
        room = () if self.writers is None else self.writers.room_in(record)
        slots = {"__slots__": (*(part.slot for part in record.parts), *room)}
        everything: object = type("Globals", (), slots)()
        self._namespace[GLOBALS] = everything
        self._run_unit(translation.globals)
        return everything

    def _run_unit(self, unit: Unit) -> None:
        self._namespace |= unit.written.names(self._bytes)
        self._listings[unit.file_name] = unit.written.listing
        exec(unit.code, self._namespace)

    # --- what it is ---------------------------------------------------------------------------

    @property
    def program(self) -> Program:
        """What is loaded."""
        return self._program

    @property
    def environment(self) -> Environment:
        """The controller around it."""
        return self._environment

    def python_source(self, block_name: str) -> str:
        """The generated Python of a block. Raises FB6020 for an unknown name."""
        return self._listings[f"<{self._block(block_name).name}>"].text

    def _block(self, name: str) -> Block:
        block = self._program.blocks.get(name.casefold())
        if block is None:
            known = [one.name for one in self._program.blocks.values()]
            raise unknown_name("block", name, known)
        return block

    # --- running ------------------------------------------------------------------------------

    def instance(
        self, block_name: str, arguments: Mapping[str, Value] = MappingProxyType({})
    ) -> CompiledInstance:
        """A fresh instance of a function block, the user's or a standard one; FB_init has run."""
        key = block_name.casefold()
        block: AnyBlock
        if key not in self._program.blocks and key in self._program.standard_blocks:
            block = self._program.standard_blocks[key]
        else:
            block = self._block(block_name)
            if block.kind is not BlockKind.FUNCTION_BLOCK:
                use = "only a FUNCTION_BLOCK has instances: call it or run it"
                raise wrong_kind_of_block(block.name, block.kind.value, use)
        record = self._model.block_record(block)
        data = self._namespace[record.class_name]()
        self._start_inside(block.name, data, retains=True)
        for method, values in own_starts(self._program, block.name, arguments):
            self._call_on(data, method, values)
        self._connect(data)
        return self._instance(record, data)

    def _start_inside(self, name: str, data: Any, *, retains: bool) -> None:
        """FB_init of the instances in a block or among the global variables."""
        function = self._program.starts.get(name.casefold())
        if function is not None:
            self._call_on(data, function, {"retains": retains})

    def _instance(self, record: Record, data: Any) -> CompiledInstance:
        return CompiledInstance(
            record,
            data,
            self._memory,
            make_call=self._keyword_call,
            call_on=self._call_on,
        )

    def _keyword_call(self, record: Record, data: Any, convert: Convert) -> Callable[..., None]:
        """A function that calls an instance, with its inputs and in-outs as keywords."""
        block = record.block
        assert block is not None
        if not isinstance(block, Block):
            run = getattr(data, run_method(block))

            def call_standard(**inputs: Any) -> None:
                self._set_others(data, convert(inputs))
                self._start(run)

            return call_standard
        self._connect(data)
        make = self._makers.get(record.class_name)
        if make is None:
            listing = write_keyword_call(record, self._facts, block)
            file_name = f"<{block.name}, called from outside>"
            self._listings[file_name] = listing
            exec(compile(listing.text, file_name, "exec"), self._namespace)
            make = self._makers[record.class_name] = self._namespace.pop("_make")
        function: Callable[..., None] = make(data, convert)
        return function

    def global_instance(self, name: str) -> CompiledInstance:
        """The instance that a data block or a global variable is."""
        part = self._model.global_record.part(name)
        if part is None:
            known = [one.name for one in self._model.global_record.parts]
            raise unknown_name("data block", name, known)
        if not isinstance(part.type, BlockType):
            use = "only an instance of a function block can be called"
            raise wrong_kind_of_block(part.name, f"variable of type {part.type}", use)
        return self._instance(self._model.record_of(part.type), self._namespace[part.slot])

    def _stopped(self, exception: Exception) -> Exception:
        """What to raise for an exception of generated code: a diagnostic if there is one."""
        if isinstance(exception, DiagnosticError):
            return exception
        return self._stopper.diagnostic(exception) or exception

    def _set_others(self, data: Any, inputs: Mapping[str, Value]) -> None:
        """Inputs and in-outs of an instance that its call does not take by their names."""
        record = self._records[type(data)]
        for name, value in inputs.items():
            part = record.part(name)
            if part is None or part.kind not in _GIVEN:
                known = [one.name for one in record.parts if one.kind in _GIVEN]
                raise unknown_name("input", name, known)
            if part.kind is VariableKind.IN_OUT:
                assert part.variable is not None
                setattr(data, part.slot, self._own_place(part.variable, part.name, value))
            else:
                self._memory.load(part.name, self._memory.location(data, part), value)

    def _connect(self, data: Any) -> None:
        """Places of their own for the in-outs that nothing is connected to yet."""
        for part in self._records[type(data)].parts:
            if part.variable and part.kind is VariableKind.IN_OUT and not hasattr(data, part.slot):
                setattr(data, part.slot, self._own_place(part.variable, part.name, None))

    def _own_place(self, variable: Variable, name: str, value: Value | None) -> Any:
        """What stands for an in-out in a call from outside: a value, a cell, or a new object."""
        if isinstance(variable.type, OpenArrayType) and value is not None:
            return self._open_array(name, variable.type, value)
        fresh = self._fresh(variable)
        if is_scalar(variable.type):
            if value is not None:
                fresh = accept_scalar(name, variable.type, value)
                fresh = fresh or None if isinstance(variable.type, ReferenceType) else fresh
            return ValueCell(fresh) if variable in self._facts.cells else fresh
        if value is not None:
            self._memory.fill(name, variable.type, fresh, value)
        return fresh

    def _open_array(self, name: str, kind: OpenArrayType, value: Value) -> OpenArray:
        """An array of the size of the value."""
        array = array_of(name, kind, value)
        scope: dict[str, Any] = {}
        exec(f"fresh = {Initializer(self._model).fresh(array)}", self._namespace, scope)
        accepted = accept(self._program, name, kind, value)
        self._memory.fill(name, array, scope["fresh"], accepted)
        return OpenArray(scope["fresh"], array.bounds)

    def _fresh(self, variable: Variable) -> Any:
        code = self._fresh_code.get(variable)
        if code is None:
            lines = Initializer(self._model).statements("fresh", variable.type, variable.initial)
            code = compile("\n".join(lines), f"<a fresh {variable.name}>", "exec")
            self._fresh_code[variable] = code
        scope: dict[str, Any] = {}
        exec(code, self._namespace, scope)
        return scope["fresh"]

    def call_function(self, name: str, arguments: Mapping[str, Value]) -> FunctionResult:
        """Call a FUNCTION, inputs and in-outs by name; what is not given has its default."""
        block = self._block(name)
        if block.kind is not BlockKind.FUNCTION:
            use = "only a FUNCTION gives a result: make an instance or run the block"
            raise wrong_kind_of_block(block.name, block.kind.value, use)
        return self._call_on(None, block, arguments)

    def call_method(
        self, path: str, method: Block, arguments: Mapping[str, Value]
    ) -> FunctionResult:
        """Call a method of the instance at a path as `global_value` takes it."""
        return self._call_on(self._find(path).read(), method, arguments)

    def _call_on(self, this: Any, block: Block, arguments: Mapping[str, Value]) -> FunctionResult:
        """Call a FUNCTION, or a method or an action of an instance."""
        if block.kind is not BlockKind.FUNCTION:
            self._start(self._namespace[self._model.name_of(block)]._run, this)
            return FunctionResult(None, {})
        shape = signature(block, self._facts)
        parameters = (*shape.inputs, *shape.in_outs)
        given = given_inputs(parameters, arguments)
        values = [
            this
            if this is not None and variable.name == RECEIVER
            else self._argument(variable, given.get(variable))
            for variable in parameters
        ]
        returned = self._start(self._namespace[self._model.name_of(block)], *values)
        results = by_variable(shape.returned, returned)
        for variable, content in zip(parameters, values, strict=True):
            if variable.kind is VariableKind.IN_OUT and variable not in results:
                if content is this:
                    continue
                in_cell = variable in self._facts.cells
                results[variable] = content.value if in_cell else content
        value = None
        if block.result is not None:
            value = self._memory.export(block.result.type, results.pop(block.result))
        outputs = {
            variable.name: self._memory.export(variable.type, results[variable])
            for variable in block.variables
            if variable in results
        }
        return FunctionResult(value, outputs)

    def _argument(self, variable: Variable, value: Value | None) -> Any:
        place = self._own_place(variable, variable.name, value)
        if isinstance(place, ValueCell) and variable.kind is not VariableKind.IN_OUT:
            return place.value
        return place

    def _start(self, action: Callable[..., Any], *arguments: Any) -> Any:
        self._cpu.passes = self._cpu.most_passes
        self._cpu.depth = 0
        try:
            return action(*arguments)
        except Exception as exception:
            self._raise(exception)

    def _raise(self, exception: Exception) -> NoReturn:
        stopped = self._stopped(exception)
        if stopped is exception:
            raise exception
        raise stopped from None

    def run_block(self, name: str, start: bytes = b"") -> None:
        """Run an organization block, a PROGRAM or a FUNCTION without parameters and result.

        A PROGRAM keeps its variables from run to run. Raises FB6022 for another kind of block.
        `start` is the start information of an organization block.
        """
        run = self._runs.get(name) or self._make_run(name)
        cpu = self._cpu
        before = cpu.passes, cpu.depth  # of what is interrupted, if anything is
        cpu.passes = cpu.most_passes
        cpu.depth = 0
        cpu.start = start
        try:
            run()
        except Exception as exception:
            self._raise(exception)
        cpu.passes, cpu.depth = before

    def _make_run(self, name: str) -> Callable[[], Any]:
        program = self.programs.get(name.casefold())
        if program is not None:
            run: Callable[[], Any] = program[1]._run
        elif (block := self._block(name)).kind is BlockKind.FUNCTION_BLOCK:
            use = "make an instance of it and call that"
            raise wrong_kind_of_block(block.name, block.kind.value, use)
        else:
            shape = signature(block, self._facts)
            if block.kind is BlockKind.FUNCTION and (shape.inputs or shape.in_outs):
                raise missing_argument(block.name, (*shape.inputs, *shape.in_outs)[0].name)
            function = self._namespace[self._model.name_of(block)]
            inputs = (*shape.inputs, *shape.in_outs)

            def with_defaults() -> Any:
                return function(*(self._argument(variable, None) for variable in inputs))

            run = with_defaults if inputs else function

        self._runs[name] = run
        return run

    # --- data ---------------------------------------------------------------------------------

    def global_value(self, path: str) -> Value:
        """Read `DB.member[3]`, a global variable, or a variable of a PROGRAM as `Main.counter`."""
        located = located_at(path, self._program, self._located, self.programs)
        if located is not None:
            assert located.address is not None
            return read_located(self._environment, located.address, located.type)
        location = self._find(path)
        return self._memory.export(location.kind, location.read())

    def set_global(self, path: str, value: Value) -> None:
        """Write what `global_value` reads."""
        located = located_at(path, self._program, self._located, self.programs)
        if located is not None:
            assert located.address is not None
            accepted = accept_scalar(path, located.type, value)
            write_located(self._environment, located.address, located.type, accepted)
            return
        self._memory.load(path, self._find(path), value)

    def reference(self, path: str) -> Reference:
        """What `global_value` reads, to be handed over itself."""
        located = located_at(path, self._program, self._located, self.programs)
        return reference_to(self, path, self._find(path) if located is None else located.type)

    def new_variable(self, kind: Type, value: Value | None) -> Reference:
        """A variable of its own; without a value it has the default of its type."""
        return new_variable(self._memory, self._bytes, kind, value)

    def _find(self, path: str) -> Location:
        return found_at(path, self._memory, self._model, self._globals, self.programs)

    def reader(self, paths: Sequence[str]) -> Reader:
        """What reads these single values."""
        return written_reader([self.location(path) for path in paths])

    def location(self, path: str) -> Location | Callable[[], Value]:
        """Where the data at a path is; what reads it if it has an absolute address."""
        located = located_at(path, self._program, self._located, self.programs)
        return self._find(path) if located is None else partial(self.global_value, path)

    def data_block(self, number: int) -> bytearray | None:
        """The bytes of a data block; None if there is none with that number in bytes."""
        return self._bytes.block(number)

    def snapshot(self) -> State:
        """All that lives in the program itself: global variables and the variables of PROGRAMs."""
        return (
            self._memory.snapshot(self._model.global_record, self._globals),
            *(self._memory.snapshot(*self.programs[key]) for key in self._own),
            self._routines.counters.snapshot(),
        )

    def restore(self, state: State) -> None:
        """Go back to a snapshot of the same program."""
        self._restore(state, remanent_too=True)

    def reset(self, warm: bool) -> None:
        """Initial values everywhere in the program; after a warm start remanent variables stay."""
        self._restore(self._initial, remanent_too=not warm)
        self._start_instances(retains=not warm)
        if self.writers is not None:
            roots = [(self._model.global_record, self._globals), *self.programs.values()]
            self.writers.forget(held_in(self._model, roots))

    def _start_instances(self, *, retains: bool) -> None:
        """FB_init of all instances that the program itself has."""
        self._start_inside(IN_GLOBALS, None, retains=retains)
        for record, data in self.programs.values():
            assert record.block is not None
            self._start_inside(record.block.name, data, retains=retains)

    def _restore(self, state: State, *, remanent_too: bool) -> None:
        assert isinstance(state, tuple)
        *contents, counters = state
        self._routines.counters.restore(counters)
        records = [
            (self._model.global_record, self._globals),
            *(self.programs[key] for key in self._own),
        ]
        for (record, data), content in zip(records, contents, strict=True):
            self._memory.restore(record, data, content, remanent_too=remanent_too)
