; Projection onto algebraic spheres (Guennebaud and Gross 2007): u(x) = u0 + g·x + u4 x², fitted to points and normals,
; x relative to the query. A plane is a sphere with u4 = 0 and no special case.
.program apss

.setting inverse_radius2: float   ; 1/h²: a neighbor at distance h or beyond weighs nothing
.setting half_beta: float         ; half the weight of curvature: 0.5 for spheres, 0.0 for planes
.setting tolerance: float         ; step at which a query is done
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
p_n = dot p, neighbor.normal
p_p = mul theta, squared
accumulate weight, theta
accumulate points, p
accumulate normals, direction
accumulate along_normals, p_n
accumulate squares, p_p

.final
inverse_weight = recip weight
m = scale points, inverse_weight
n = scale normals, inverse_weight
mean_along = dot points, n
mean_square = dot points, m
numerator = sub along_normals, mean_along
denominator = sub squares, mean_square
quotient = div numerator, denominator
curvature = mul half_beta, quotient
; Neighbors at one place have no curvature: what is left of the difference is rounding.
least = mul squares, 2.44140625e-4
extends = less least, denominator
u4 = select extends, curvature, 0.0
double_u4 = add u4, u4
bend = scale m, double_u4
g = sub n, bend
m_g = dot m, g
square = mul squares, inverse_weight
u4_square = mul u4, square
minus_u0 = add m_g, u4_square
; The step to the surface along g: 2 u0 / (|g| + √(g² − 4 u4 u0)), towards −g.
magnitude = length2 g
double_minus_u0 = add minus_u0, minus_u0
four_u4_u0 = mul double_u4, double_minus_u0
discriminant = add magnitude, four_u4_u0
under_root = max discriminant, 0.0
root = sqrt under_root
inverse_length = rsqrt magnitude
length = mul magnitude, inverse_length
reach = add length, root
step = div double_minus_u0, reach
normal_there = scale g, inverse_length
forward = scale normal_there, step
foot = add query.position, forward
weighs = less 0.0, weight
directed = less 0.0, magnitude
finite = less magnitude, 1.0e38
meets = less_or_equal 0.0, discriminant
there = and weighs, directed
on_sphere = and finite, meets
valid = and there, on_sphere
none = vector 0.0, 0.0, 0.0
surface = select valid, foot, query.position
normal = select valid, normal_there, none
distance = abs step
close = less_or_equal distance, tolerance
invalid = not valid
finished = or close, invalid
curvature_there = select valid, u4, 0.0
output position, surface
output normal, normal
output curvature, curvature_there
output valid, valid
move surface
done finished
search true
