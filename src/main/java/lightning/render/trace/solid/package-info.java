/**
 * The canonical solids: how each is met by rays, scalar and in lanes, and what its surface is. A solid is a {@link
 * lightning.render.trace.solid.SolidGeometry} in readable code, its lanes beside it, and a name among the {@link lightning.render.trace.solid.SolidKind}s.
 */
package lightning.render.trace.solid;
