"""A TIA program of any size, as a plant has it: types, data blocks, function blocks, functions.

Every station is a function block of about a hundred lines with a step chain, timers, edges, a
table and alarms; some stations share helpers. The text has no mistakes and no warnings.
"""

from collections.abc import Iterator

_HELPERS = """\
TYPE "typeStation"
VERSION : 0.1
   STRUCT
      enable : Bool;   // released by the operator
      automatic : Bool;
      setPoint : Real;
      limits : Array[0..1] of Real;
      counts : Array[0..15] of DInt;
   END_STRUCT;
END_TYPE

FUNCTION "ScaleLinear" : Real
{ S7_Optimized_Access := 'TRUE' }
VERSION : 0.1
   VAR_INPUT
      raw : Int;
      low : Real;
      high : Real;
   END_VAR
   VAR_TEMP
      tempSpan : Real;
   END_VAR
BEGIN
   #tempSpan := #high - #low;
   IF #tempSpan > 0.0 THEN
      #ScaleLinear := INT_TO_REAL(#raw) / 27648.0 * #tempSpan + #low;
   ELSE
      #ScaleLinear := #low;
   END_IF;
END_FUNCTION
"""

_STATION = """\
FUNCTION_BLOCK "Station{n}"
TITLE = Station {n}
{{ S7_Optimized_Access := 'TRUE' }}
AUTHOR : bench
VERSION : 0.1
   VAR_INPUT
      start : Bool;   // rising edge starts one cycle
      stop : Bool;
      raw : Int;
      mode : USInt;
   END_VAR
   VAR_OUTPUT
      busy : Bool;
      error : Bool;
      status : Word;
      value : Real;
   END_VAR
   VAR_IN_OUT
      station : "typeStation";
   END_VAR
   VAR
      instStart {{InstructionName := 'R_TRIG'; LibVersion := '1.0'}} : R_TRIG;
      instDelay {{InstructionName := 'TON_TIME'; LibVersion := '1.0'}} : TON_TIME;
      instWatch {{InstructionName := 'TON_TIME'; LibVersion := '1.0'}} : TON_TIME;
      statStep : Int;
      statSum : DInt;
      statAverage : Real;
      statTable : Array[0..15] of Int;
      statIndex : Int;
   END_VAR
   VAR_TEMP
      tempIndex : Int;
      tempHigh : Int;
      tempScaled : Real;
      tempRun : Bool;
   END_VAR
   VAR CONSTANT
      STEP_IDLE : Int := 0;
      STEP_FILL : Int := 10;
      STEP_MIX : Int := 20;
      STEP_DRAIN : Int := 30;
      LAST : Int := 15;
      NO_ERROR : Word := 16#0000;
      TOO_HIGH : Word := 16#8{code:03X};
   END_VAR
BEGIN
   REGION Inputs
      // The edge is taken in every cycle, whatever the step.
      #instStart(CLK := #start);
      #tempRun := #station.enable AND NOT #stop;
      #tempScaled := "ScaleLinear"(
         raw := #raw, low := #station.limits[0], high := #station.limits[1]);
   END_REGION

   REGION Step chain
      CASE #statStep OF
         STEP_IDLE:
            #busy := FALSE;
            IF #instStart.Q AND #tempRun THEN
               #statStep := #STEP_FILL;
               #busy := TRUE;
            END_IF;
         STEP_FILL:
            IF #tempScaled >= #station.setPoint * {factor}.5 THEN
               #statStep := #STEP_MIX;
            ELSIF NOT #tempRun THEN
               #statStep := #STEP_IDLE;
            END_IF;
         STEP_MIX:
            IF #instDelay.Q THEN
               #statStep := #STEP_DRAIN;
            END_IF;
         STEP_DRAIN:
            IF #tempScaled < 0.5 OR #mode = {mode} THEN
               #statStep := #STEP_IDLE;
               #station.counts[{slot}] := #station.counts[{slot}] + 1;
            END_IF;
         ELSE
            #statStep := #STEP_IDLE;   // after a download
      END_CASE;
      #instDelay(IN := #statStep = #STEP_MIX, PT := T#{seconds}s);
      #instWatch(IN := #statStep <> #STEP_IDLE, PT := T#1m{seconds}s);
   END_REGION

   REGION Average
      // A ring of the last values; the highest one is looked for.
      #statTable[#statIndex] := #raw;
      #statIndex += 1;
      IF #statIndex > #LAST THEN
         #statIndex := 0;
      END_IF;
      #statSum := 0;
      #tempHigh := #statTable[0];
      FOR #tempIndex := 0 TO #LAST DO
         #statSum := #statSum + #statTable[#tempIndex];
         IF #statTable[#tempIndex] > #tempHigh THEN
            #tempHigh := #statTable[#tempIndex];
         END_IF;
      END_FOR;
      #statAverage := DINT_TO_REAL(#statSum) / 16.0;
      #value := LIMIT(
         MN := 0.0, IN := #statAverage + INT_TO_REAL(#tempHigh) * 0.{slot:02d}, MX := 27648.0);
   END_REGION

   REGION Alarms
      #error := #instWatch.Q OR #tempScaled > #station.limits[1];
      IF #error THEN
         #status := #TOO_HIGH OR SHL(IN := WORD#16#0001, N := {slot});
      ELSIF #station.automatic AND (#raw > {high} OR #raw < -{high}) THEN
         #status := 16#8201;
      ELSE
         #status := #NO_ERROR;
      END_IF;
      "Plant".sum := "Plant".sum + #tempHigh;
   END_REGION
END_FUNCTION_BLOCK

DATA_BLOCK "Station{n}_DB"
{{ S7_Optimized_Access := 'TRUE' }}
VERSION : 0.1
"Station{n}"
BEGIN
   statIndex := {slot};
END_DATA_BLOCK
"""


def _parts() -> Iterator[str]:
    yield _HELPERS
    number = 0
    while True:
        number += 1
        yield _STATION.format(
            n=number,
            code=number % 4096,
            factor=number % 9,
            mode=number % 5,
            slot=number % 16,
            seconds=number % 50 + 1,
            high=number % 27648 + 1,
        )


def _main(stations: int) -> str:
    calls = "".join(
        f'   "Station{n}_DB"(start := %I{n // 8 % 1000}.{n % 8}, stop := FALSE, '
        f"raw := {n % 27648},\n"
        f'      mode := {n % 5}, station := "Plant".stations[{n % 100}]);\n'
        for n in range(1, stations + 1)
    )
    return (
        'DATA_BLOCK "Plant"\nVERSION : 0.1\n   VAR\n      sum : DInt;\n'
        '      stations : Array[0..99] of "typeStation";\n   END_VAR\nBEGIN\nEND_DATA_BLOCK\n\n'
        f'ORGANIZATION_BLOCK "Main"\nVERSION : 0.1\nBEGIN\n{calls}END_ORGANIZATION_BLOCK\n'
    )


def plc_text(lines: int) -> str:
    """A TIA program of about that many lines (never fewer than about 300)."""
    parts: list[str] = []
    count = 0
    for part in _parts():
        if parts and count >= lines:
            break
        parts.append(part)
        count += part.count("\n") + 1
    return "\n".join([*parts, _main(len(parts) - 1)])
