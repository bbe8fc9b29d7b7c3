# points_pins, Synopsys design constraints (Quartus, OpenSTA): the one clock.
create_clock -name clk -period 10.000 [get_ports clk]
