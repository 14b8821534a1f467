/** Animation: keyframes of a scene's camera, lights, light groups, shapes and groups, and the scene at each frame. */
package lightning.scene.shot;
