/** Parts that all importers share: files to copy, names, units, bounds, and the assembled scene. */
@NullMarked
package lightning.format.exchange.assembly;

import org.jspecify.annotations.NullMarked;
