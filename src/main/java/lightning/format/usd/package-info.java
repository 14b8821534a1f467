/**
 * Stages of Universal Scene Description: a converter in Python reads them with usd-core and describes them in JSON with arrays, which this
 * package reads and checks like any other program's file.
 */
@NullMarked
package lightning.format.usd;

import org.jspecify.annotations.NullMarked;
