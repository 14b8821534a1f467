/** The tree of shapes and groups: geometry without materials. */
package lightning.scene.node;
