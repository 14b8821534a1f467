/**
 * Arbitrary scenes and edits for property tests: every edge case of the format among mostly ordinary values, so that most images show
 * something. Values shrink towards the simple ones.
 */
package lightning.sample;
