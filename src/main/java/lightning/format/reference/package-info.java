/** Images that pictures are compared with and matched to, in any format. */
@NullMarked
package lightning.format.reference;

import org.jspecify.annotations.NullMarked;
