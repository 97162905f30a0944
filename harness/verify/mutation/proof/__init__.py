"""Proofs that a change makes no difference, by an SMT solver.

One call of a block is a function from what its variables hold, and the world outside, to what they
hold behind the call. The checked statements are read into terms of the solver, those of the block
and those of the mutant, from the same start. If no start can tell the results apart, the two are
equivalent. What cannot be said in terms is unknown, which is no proof.

What the proof takes for granted: a block that is called does the same if it is given the same and
the world is the same; nobody writes the statics of a block from outside of the program. Temporary
variables begin with anything.
"""
