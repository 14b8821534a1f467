/** Other processes: this program again, and programs that convert files. */
@NullMarked
package lightning.base.process;

import org.jspecify.annotations.NullMarked;
