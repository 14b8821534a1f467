/** Values that lights, materials, shapes and cameras consist of, and the limits of all of them. */
package lightning.scene.value;
