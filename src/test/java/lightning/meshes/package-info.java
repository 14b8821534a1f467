/** Generators of the sample meshes and of scenes that are too long to write by hand. */
package lightning.meshes;
