/** Content of files that a scene uses: textures, environment maps, gobos and IES profiles. */
package lightning.scene.asset;
