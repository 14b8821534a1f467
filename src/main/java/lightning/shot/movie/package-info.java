/** Export of a shot: its frames as numbered images or as a video. */
package lightning.shot.movie;
