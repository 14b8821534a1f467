/** Files that a scene names: where they are, and how they are decoded. */
package lightning.format.jen.asset;
