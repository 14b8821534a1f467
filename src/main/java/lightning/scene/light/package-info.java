/** Lights, light groups and the rig that resolves them to what shines. */
package lightning.scene.light;
