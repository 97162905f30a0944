"""The reference: pages about what the catalogue, a plant and its blocks hold.

Pages are made of the parts in `document`, whatever they are written as; `pages` has a module for
each kind of page. What comes out of a simulation is handed in as data.
"""
