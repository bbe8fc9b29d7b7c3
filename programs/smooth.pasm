; Non-linear smoothing (Jones, Durand and Desbrun 2003): each neighbor predicts where the query lies on its own plane;
; predictions count less the farther away the neighbor is, and the farther the prediction is, so that edges stay.
.program smooth

.setting spatial: float           ; 1/(2σ²) of distances from neighbors
.setting influence: float         ; 1/(2σ²) of distances from predictions
.neighbor normal: float3          ; of length 1, mollified
.neighbor area: float             ; that the neighbor stands for

.kernel
d = sub neighbor.position, query.position
squared = length2 d
; The prediction is at `height` along the neighbor's normal.
height = dot neighbor.normal, d
height2 = mul height, height
near = mul squared, spatial
similar = mul height2, influence
exponent = add near, similar
gaussian = exp_neg exponent
w = mul gaussian, neighbor.area
along = mul w, height
step = scale neighbor.normal, along
accumulate weight, w
accumulate steps, step

.final
inverse_weight = recip weight
step = scale steps, inverse_weight
weighs = less 0.0, weight
step2 = length2 step
finite = less step2, 1.0e38
valid = and weighs, finite
smoothed = add query.position, step
surface = select valid, smoothed, query.position
output position, surface
output valid, valid
