; Normals as of Hoppe et al. 1992: the direction in which the neighbors vary least, on the side of the viewpoint, as a
; scanner sees them. `variation` and `valid` are those of `covariance`; what is not valid has a normal of zero.
.program normals

.setting inverse_radius2: float   ; 1/h²: a neighbor at distance h or beyond weighs nothing
.setting least_spread: float      ; sum of the products of the variances' shares below which it counts as a line
.setting viewpoint: float3

.kernel
d = sub neighbor.position, query.position
squared = length2 d
ratio = mul squared, inverse_radius2
below = sub 1.0, ratio
falloff = max below, 0.0
falloff2 = mul falloff, falloff
theta = mul falloff2, falloff2
p = scale d, theta
p_xx = mul p.x, d.x
p_xy = mul p.x, d.y
p_xz = mul p.x, d.z
p_yy = mul p.y, d.y
p_yz = mul p.y, d.z
p_zz = mul p.z, d.z
accumulate weight, theta
accumulate points, p
accumulate xx, p_xx
accumulate xy, p_xy
accumulate xz, p_xz
accumulate yy, p_yy
accumulate yz, p_yz
accumulate zz, p_zz

.final
; The covariance about the mean: Σ θ d dᵀ − Σ θ d · meanᵀ, all relative to the query.
inverse_weight = recip weight
m = scale points, inverse_weight
m_xx = mul points.x, m.x
m_xy = mul points.x, m.y
m_xz = mul points.x, m.z
m_yy = mul points.y, m.y
m_yz = mul points.y, m.z
m_zz = mul points.z, m.z
v_xx = sub xx, m_xx
v_xy = sub xy, m_xy
v_xz = sub xz, m_xz
v_yy = sub yy, m_yy
v_yz = sub yz, m_yz
v_zz = sub zz, m_zz
; a: the same with a trace of 1, so that nothing behind it depends on the scale.
v_xx_yy = add v_xx, v_yy
trace = add v_xx_yy, v_zz
inverse_trace = recip trace
a_xx = mul v_xx, inverse_trace
a_xy = mul v_xy, inverse_trace
a_xz = mul v_xz, inverse_trace
a_yy = mul v_yy, inverse_trace
a_yz = mul v_yz, inverse_trace
a_zz = mul v_zz, inverse_trace
; Its adjugate has the same eigenvectors, each with the product of the two other values: the smallest's is the largest.
yy_zz = mul a_yy, a_zz
yz_yz = mul a_yz, a_yz
xx_zz = mul a_xx, a_zz
xz_xz = mul a_xz, a_xz
xx_yy = mul a_xx, a_yy
xy_xy = mul a_xy, a_xy
xz_yz = mul a_xz, a_yz
xy_zz = mul a_xy, a_zz
xy_yz = mul a_xy, a_yz
xz_yy = mul a_xz, a_yy
xy_xz = mul a_xy, a_xz
yz_xx = mul a_yz, a_xx
j_xx = sub yy_zz, yz_yz
j_yy = sub xx_zz, xz_xz
j_zz = sub xx_yy, xy_xy
j_xy = sub xz_yz, xy_zz
j_xz = sub xy_yz, xz_yy
j_yz = sub xy_xz, yz_xx
j_xx_yy = add j_xx, j_yy
spread = add j_xx_yy, j_zz
inverse_spread = recip spread
s_xx[0] = mul j_xx, inverse_spread
s_xy[0] = mul j_xy, inverse_spread
s_xz[0] = mul j_xz, inverse_spread
s_yy[0] = mul j_yy, inverse_spread
s_yz[0] = mul j_yz, inverse_spread
s_zz[0] = mul j_zz, inverse_spread
; Squared five times, the largest is left: the ratio of two values is raised to the power of 32. The trace, 1 at first,
; does not fall below 3 · 3^-32.
.repeat i 0 5
    x2 = mul s_xx[i], s_xx[i]
    y2 = mul s_yy[i], s_yy[i]
    z2 = mul s_zz[i], s_zz[i]
    xy2 = mul s_xy[i], s_xy[i]
    xz2 = mul s_xz[i], s_xz[i]
    yz2 = mul s_yz[i], s_yz[i]
    x2_xy2 = add x2, xy2
    y2_xy2 = add y2, xy2
    z2_xz2 = add z2, xz2
    s_xx[i+1] = add x2_xy2, xz2
    s_yy[i+1] = add y2_xy2, yz2
    s_zz[i+1] = add z2_xz2, yz2
    t_xy = add s_xx[i], s_yy[i]
    t_xz = add s_xx[i], s_zz[i]
    t_yz = add s_yy[i], s_zz[i]
    o_xy = mul s_xz[i], s_yz[i]
    o_xz = mul s_xy[i], s_yz[i]
    o_yz = mul s_xy[i], s_xz[i]
    u_xy = mul s_xy[i], t_xy
    u_xz = mul s_xz[i], t_xz
    u_yz = mul s_yz[i], t_yz
    s_xy[i+1] = add u_xy, o_xy
    s_xz[i+1] = add u_xz, o_xz
    s_yz[i+1] = add u_yz, o_yz
.end
; Its longest column.
c_x = vector s_xx[5], s_xy[5], s_xz[5]
c_y = vector s_xy[5], s_yy[5], s_yz[5]
c_z = vector s_xz[5], s_yz[5], s_zz[5]
is_y = less s_xx[5], s_yy[5]
c_xy = select is_y, c_y, c_x
larger = max s_xx[5], s_yy[5]
is_z = less larger, s_zz[5]
column = select is_z, c_z, c_xy
column2 = length2 column
inverse_length = rsqrt column2
n = scale column, inverse_length
; The share of the variance along it.
a_x = vector a_xx, a_xy, a_xz
a_y = vector a_xy, a_yy, a_yz
a_z = vector a_xz, a_yz, a_zz
an_x = dot a_x, n
an_y = dot a_y, n
an_z = dot a_z, n
an = vector an_x, an_y, an_z
share = dot an, n
; False of NaNs, too.
weighs = less 0.0, weight
extends = less 0.0, trace
spans = less least_spread, spread
there = and weighs, extends
valid = and there, spans
none = vector 0.0, 0.0, 0.0
to_viewpoint = sub viewpoint, query.position
facing = dot n, to_viewpoint
away = less facing, 0.0
opposite = neg n
oriented = select away, opposite, n
normal = select valid, oriented, none
positive = max share, 0.0
variation = select valid, positive, 0.0
output normal, normal
output variation, variation
output valid, valid
