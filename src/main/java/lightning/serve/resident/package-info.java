/** Process that stays and runs commands of other processes of the same user, as if each ran in its own. */
@NullMarked
package lightning.serve.resident;

import org.jspecify.annotations.NullMarked;
