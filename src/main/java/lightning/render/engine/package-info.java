/**
 * Interface between the computation of a tile and its implementations: {@link lightning.render.engine.Engine}. Each subpackage
 * is one implementation.
 */
@NullMarked
package lightning.render.engine;

import org.jspecify.annotations.NullMarked;
