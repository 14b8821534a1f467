/** Import of USD: materials, lights, shapes and their tracks. */
@NullMarked
package lightning.format.exchange.usd;

import org.jspecify.annotations.NullMarked;
