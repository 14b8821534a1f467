/** Materials and their attributes. */
package lightning.scene.material;
