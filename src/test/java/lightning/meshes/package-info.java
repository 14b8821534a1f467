/** Makes the meshes of the scenes: bodies turned, twisted and grown by formulas, and the scenes that are too long to write. */
package lightning.meshes;
