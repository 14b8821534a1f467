/**
 * A shot: keys of a scene's camera, lights, banks, shapes and groups over frames, and the ordinary scene of each frame.
 */
package lightning.scene.shot;
