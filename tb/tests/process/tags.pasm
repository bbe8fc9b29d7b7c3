; Sums that hang on which neighbors a query has, and not on their order. All are summed up twice.
.program tags
.neighbor tag: int
.kernel
accumulate tags, neighbor.tag
.final
output tags, tags
output neighbors, neighbors
second = less 1, count
done second
