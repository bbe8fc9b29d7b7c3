; Acceleration of a fluid's particles (Müller et al. 2003): pressure by the gradient of the spiky kernel, viscosity by
; the Laplacian of its own; both have the factor 45/(π h⁶). A particle at the query's place pushes nowhere.
.program sph_forces

.setting radius: float            ; h
.setting normalization: float     ; 45/(π h⁶)
.setting viscosity: float
.setting gravity: float3
.query velocity: float3
.query density: float
.query pressure: float
.neighbor velocity: float3
.neighbor density: float
.neighbor pressure: float
.neighbor mass: float

.kernel
d = sub neighbor.position, query.position
squared = length2 d
; Of a distance of zero, d is zero, too.
above_zero = max squared, 1.0e-30
inverse_distance = rsqrt above_zero
distance = mul squared, inverse_distance
inside = sub radius, distance
reach = max inside, 0.0
inverse_density = recip neighbor.density
volume = mul neighbor.mass, inverse_density
weight = mul volume, reach
pressures = add query.pressure, neighbor.pressure
mean_pressure = mul pressures, 0.5
push = mul weight, reach
pushed = mul push, mean_pressure
per_distance = mul pushed, inverse_distance
repulsion = scale d, per_distance
relative = sub neighbor.velocity, query.velocity
drag = scale relative, weight
accumulate repulsions, repulsion
accumulate drags, drag

.final
viscous = scale drags, viscosity
force = sub viscous, repulsions
inverse_density = recip query.density
factor = mul normalization, inverse_density
internal = scale force, factor
acceleration = add internal, gravity
output acceleration, acceleration
