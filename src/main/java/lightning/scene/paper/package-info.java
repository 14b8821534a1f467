/** The edits of the paper, and more of materials and shapes, for any scene. */
package lightning.scene.paper;
