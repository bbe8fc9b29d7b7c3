; Projection onto the surface of weighted planes (thesis 6.2, equations 6.1 to 6.4; Alexa and Adamson 2004). Each
; iteration finds the plane through the weighted mean of the neighbors, its normal their weighted normal, and puts the
; query at the foot of its start on it.
.program mls

.setting inverse_radius2: float   ; 1/h²: a neighbor at distance h or beyond weighs nothing
.setting tolerance: float         ; distance from the plane at which a query is done
.neighbor normal: float3
.state start: float3

.init
first = equal count, 0
store start, query.position if first

.kernel
d = sub neighbor.position, query.position
squared = length2 d
ratio = mul squared, inverse_radius2
below = sub 1.0, ratio
falloff = max below, 0.0
falloff2 = mul falloff, falloff
theta = mul falloff2, falloff2
point = scale d, theta
direction = scale neighbor.normal, theta
accumulate weight, theta
accumulate points, point
accumulate normals, direction

.final
; The mean a relative to the query, so that far coordinates do not cancel.
inverse_weight = recip weight
a = scale points, inverse_weight
magnitude = length2 normals
inverse_length = rsqrt magnitude
n = scale normals, inverse_length
residual = dot n, a
distance = abs residual
; False of NaNs, too.
weighs = less 0.0, weight
directed = less 0.0, magnitude
finite = less distance, 1.0e38
there = and weighs, directed
valid = and there, finite
; Step 4 of 6.2 with the sign it has to have: x' = x + n (n · (a(x') − x)).
moved_by = sub query.position, start
from_start = add moved_by, a
along = dot n, from_start
step = scale n, along
foot = add start, step
surface = select valid, foot, query.position
none = vector 0.0, 0.0, 0.0
normal = select valid, n, none
residual_there = select valid, residual, 0.0
close = less_or_equal distance, tolerance
invalid = not valid
finished = or close, invalid
output position, surface
output normal, normal
output residual, residual_there
output valid, valid
move surface
done finished
search true
