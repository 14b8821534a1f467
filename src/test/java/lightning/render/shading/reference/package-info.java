/** The slow and readable tracer that follows §2.1 of the paper literally: the oracle of all equality tests. */
package lightning.render.shading.reference;
