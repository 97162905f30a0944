"""The simulated gateways between a fieldbus and the inverters' serial line, one package each."""
