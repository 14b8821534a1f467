/**
 * Canonical solids: ray intersection, scalar and in lanes, and surface properties. Each solid has a readable
 * {@link lightning.render.trace.solid.SolidGeometry}, a lane version, and a {@link lightning.render.trace.solid.SolidKind}.
 */
@NullMarked
package lightning.render.trace.solid;

import org.jspecify.annotations.NullMarked;
