; Resampling: each query carries its offsets in a pattern on the tangent plane. The first iteration finds the plane and
; moves the query to its place in the pattern; each one behind it puts the query on the plane of its neighbors there.
.program resample

.setting inverse_radius2: float   ; 1/h²: a neighbor at distance h or beyond weighs nothing
.setting tolerance: float         ; distance from the plane at which a query is done
.query u: float
.query v: float
.neighbor normal: float3
.kernel
d = sub neighbor.position, query.position
squared = length2 d
ratio = mul squared, inverse_radius2
below = sub 1.0, ratio
falloff = max below, 0.0
falloff2 = mul falloff, falloff
theta = mul falloff2, falloff2
p = scale d, theta
direction = scale neighbor.normal, theta
accumulate weight, theta
accumulate points, p
accumulate normals, direction

.final
inverse_weight = recip weight
a = scale points, inverse_weight
magnitude = length2 normals
inverse_length = rsqrt magnitude
n = scale normals, inverse_length
weighs = less 0.0, weight
directed = less 0.0, magnitude
residual = dot n, a
distance = abs residual
finite = less distance, 1.0e38
there = and weighs, directed
valid = and there, finite
begins = equal count, 0
later = not begins
; A tangent frame without a special direction that fails (Duff et al. 2017).
below = less n.z, 0.0
sign = select below, -1.0, 1.0
sign_z = add sign, n.z
inverse_z = recip sign_z
factor = neg inverse_z
n_xy = mul n.x, n.y
b = mul n_xy, factor
x_factor = mul n.x, factor
x2_factor = mul n.x, x_factor
signed_x2 = mul sign, x2_factor
first_x = add 1.0, signed_x2
first_y = mul sign, b
signed_x = mul sign, n.x
first_z = neg signed_x
y_factor = mul n.y, factor
y2_factor = mul n.y, y_factor
second_y = add sign, y2_factor
second_z = neg n.y
first = vector first_x, first_y, first_z
second = vector b, second_y, second_z
along_u = scale first, query.u
along_v = scale second, query.v
offset = add along_u, along_v
; The place in the pattern is on the plane: the query's own foot, and the offsets from it.
to_plane = scale n, residual
to_place = add to_plane, offset
step = select begins, to_place, to_plane
place = add query.position, step
surface = select valid, place, query.position
none = vector 0.0, 0.0, 0.0
normal = select valid, n, none
close = less_or_equal distance, tolerance
invalid = not valid
settled = and close, later
finished = or settled, invalid
output position, surface
output normal, normal
output valid, valid
move surface
done finished
search true
