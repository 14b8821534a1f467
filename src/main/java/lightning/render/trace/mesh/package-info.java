/**
 * Triangle meshes as rays meet them, in the space that their vertices are given in: which triangle a ray meets, by a tree of boxes
 * or by asking every one, and what the surface is there.
 */
package lightning.render.trace.mesh;
