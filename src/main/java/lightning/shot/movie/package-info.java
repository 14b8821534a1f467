/** Export of a shot: its frames as numbered images or as a video. */
@NullMarked
package lightning.shot.movie;

import org.jspecify.annotations.NullMarked;
