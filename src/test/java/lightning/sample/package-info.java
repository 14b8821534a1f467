/**
 * Arbitrary scenes and edits for the properties: every hard case that the format allows, among mostly
 * ordinary values, so that most pictures show something. Values shrink towards the plain ones.
 */
package lightning.sample;
