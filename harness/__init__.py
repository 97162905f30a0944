"""The harness: runs PLC text scan by scan against simulated gateways and inverters."""
