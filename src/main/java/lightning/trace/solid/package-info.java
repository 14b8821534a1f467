/**
 * The canonical solids: how each is met by rays, scalar and in lanes, and what its surface is. A solid is a {@link
 * lightning.trace.solid.Form} in readable code, its lanes beside it, and a name among the {@link lightning.trace.solid.Kind}s.
 */
package lightning.trace.solid;
