"""fbgen: function blocks for Toshiba VF inverters, generated from a catalogue of device facts."""

__version__ = "0.1.0"
