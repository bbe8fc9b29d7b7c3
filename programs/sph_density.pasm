; Density and pressure of a fluid's particles (Müller et al. 2003): ρ = Σ m W(r), W(r) = 315/(64 π h³) (1 − r²/h²)³.
.program sph_density

.setting inverse_radius2: float   ; 1/h²
.setting normalization: float     ; 315/(64 π h³)
.setting stiffness: float
.setting rest_density: float
.neighbor mass: float

.kernel
d = sub neighbor.position, query.position
squared = length2 d
ratio = mul squared, inverse_radius2
below = sub 1.0, ratio
falloff = max below, 0.0
falloff2 = mul falloff, falloff
falloff3 = mul falloff2, falloff
share = mul falloff3, neighbor.mass
accumulate mass, share

.final
density = mul mass, normalization
excess = sub density, rest_density
pressure = mul excess, stiffness
output density, density
output pressure, pressure
