; Looks at the farthest neighbor, stores under conditions, reads all that there is, moves and searches now and then.
.program farthest
.setting factor: float
.query limit: int
.state far: float3
.state best: bool
.state turns: int
.init
first = equal count, 0
scaled = scale farthest.position, factor
store far, scaled if first
store turns, count
.kernel
d = sub neighbor.position, far
product = mul d.x, query.position.y
accumulate products, product
accumulate points, d
.final
late = less 2, count
many = less neighbors, query.limit
both = and late, many
either = or late, many
store best, either if many
one = add turns, count
odd = and one, 1
even = equal odd, 0
place = add points, query.position
output far, far
output best, best
output products, products
output turns, one
move place if many
done both
search even
