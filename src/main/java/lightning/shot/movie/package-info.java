/**
 * A shot as files: its frames one after the other, as numbered pictures or as a film.
 */
package lightning.shot.movie;
