# points_top on an AMD 7-series device (Vivado): the one clock.
# Pins belong to the board: add PACKAGE_PIN and IOSTANDARD lines for yours.
create_clock -name clk -period 10.000 [get_ports clk]
