/** Attributes that other formats lack, as JSON inside their files. */
@NullMarked
package lightning.format.exchange.json;

import org.jspecify.annotations.NullMarked;
