/**
 * The seam between what is computed of a tile and how: {@link lightning.engine.Engine}. Each package below it is one way.
 */
package lightning.engine;
